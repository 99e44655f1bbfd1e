//! Credentials of a fleet: certificates of the fleet's own authority.

use std::collections::BTreeSet;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::time::{Duration, SystemTime};

use data_encoding::BASE64;
use dobot_api::{Folders, is_fleet_name, write_private};
use rcgen::{BasicConstraints, CertificateParams, DnType, IsCa, Issuer, KeyPair};
use x509_parser::pem::parse_x509_pem;

use crate::id::new_id;
use crate::identity::{Identity, Peer, now_s};

/// Credentials of a station: a certificate of the fleet's authority, and its key. A folder contains
/// them as `authority.pem`, `certificate.pem` and `key.pem`, and `revoked.txt` if certificates are
/// revoked.
#[derive(Clone)]
pub struct Credentials {
    authority: String,
    certificate: String,
    key: String,
    revoked: BTreeSet<String>,
    /// The file that lists the revoked certificates; it may grow later.
    revoked_file: Option<PathBuf>,
    /// Whether these are a user's credentials for the programs on this machine.
    is_local: bool,
}

const AUTHORITY: &str = "authority.pem";
const AUTHORITY_KEY: &str = "authority-key.pem";
const CERTIFICATE: &str = "certificate.pem";
const KEY: &str = "key.pem";
/// The file of the revoked certificates, by common name.
const REVOKED: &str = "revoked.txt";
/// The file of all certificates that the authority has issued.
const ISSUED: &str = "issued.txt";

/// The validity of a member's certificate, in days.
const DAYS: u64 = 365;
/// Days before expiry from which a warning is given.
const WARN_DAYS: i64 = 30;

/// The error returned when credentials cannot be read or created.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CredentialsError {
    /// A file is missing.
    #[error(
        "{file} is missing; `dobot fleet certificates FOLDER NAME...` creates a folder with authority.pem, certificate.pem and key.pem for each NAME"
    )]
    Missing {
        /// The file.
        file: String,
    },
    /// A file has invalid contents.
    #[error("{0}; `dobot fleet certificates FOLDER NAME...` creates new ones")]
    Unusable(&'static str),
    /// The other members reject the certificate.
    #[error(
        "the certificate {certificate} cannot be used: {why}; `dobot fleet revoke` and `dobot fleet certificates` replace it"
    )]
    NotAccepted {
        /// The name of the certificate.
        certificate: String,
        /// The reason.
        why: &'static str,
    },
    /// No certificate of this name was issued.
    #[error(
        "no certificate for {name:?} was issued in {folder}; issued.txt in that folder lists the issued ones"
    )]
    NotIssued {
        /// The name.
        name: String,
        /// The folder of the authority.
        folder: String,
    },
    /// The system has no folder for this user's programs.
    #[error(
        "this user has no home folder for the certificates of this machine; use those of another folder with `--fleet=FOLDER`"
    )]
    NoHome,
    /// An invalid name of a station.
    #[error(
        "{0:?} is not a valid station name; allowed are 1 to 40 lowercase letters a to z, digits and hyphens, beginning with a letter"
    )]
    Name(String),
    /// An invalid host name or address.
    #[error(
        "{0:?} is not a valid host; allowed are host names and addresses to which others connect, as in router=router.school,192.168.7.1"
    )]
    Host(String),
    /// A certificate of this name exists.
    #[error("{0} already exists; nothing was created")]
    Exists(String),
    /// A file cannot be read or written.
    #[error("{file} cannot be read or written")]
    File {
        /// The file.
        file: String,
        /// The cause.
        #[source]
        source: std::io::Error,
    },
    /// The certificate cannot be created.
    #[error("the certificate cannot be created: {0}")]
    Certificate(#[from] rcgen::Error),
    /// The system has no random numbers.
    #[error("the system has no random numbers: {0}")]
    Random(getrandom::Error),
}

impl Credentials {
    /// Reads the credentials in a folder.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`] if a file is missing, or the certificate has expired or is revoked.
    pub fn read(folder: &Path) -> Result<Self, CredentialsError> {
        let [authority, certificate, key] =
            [AUTHORITY, CERTIFICATE, KEY].map(|name| folder.join(name));
        if let Some(missing) = [&authority, &certificate, &key]
            .into_iter()
            .find(|file| !file.is_file())
        {
            return Err(CredentialsError::Missing {
                file: missing.display().to_string(),
            });
        }
        let credentials = Self {
            authority: read(&authority)?,
            certificate: read(&certificate)?,
            key: read(&key)?,
            revoked: lines(&folder.join(REVOKED))?,
            revoked_file: Some(folder.join(REVOKED)),
            is_local: false,
        };
        credentials.identity()?;
        Ok(credentials)
    }

    /// Returns this user's credentials for a program on this machine, with this name. Their
    /// authority is created if there is none, readable by this user only.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`].
    pub fn of_person(name: &str) -> Result<Self, CredentialsError> {
        let folders = Folders::of_person().ok_or(CredentialsError::NoHome)?;
        Self::local(&folders.data().join("fleet-authority"), name)
    }

    /// Returns local credentials whose authority is in this folder.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`].
    pub fn local(folder: &Path, name: &str) -> Result<Self, CredentialsError> {
        let holder: Holder = format!("{name}=localhost,127.0.0.1,::1").parse()?;
        let credentials = Authority::shared(folder)?.certify(&holder)?;
        Ok(Self {
            is_local: true,
            ..credentials
        })
    }

    /// Creates a folder for each holder. The authority is created if there is none; the holder of
    /// its key can admit others.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`]; no certificate is replaced.
    pub fn make(folder: &Path, holders: &[Holder]) -> Result<Vec<Self>, CredentialsError> {
        let mut places = holders.iter().map(|holder| folder.join(&holder.name));
        if let Some(there) = places.find(|folder| folder.exists()) {
            return Err(CredentialsError::Exists(there.display().to_string()));
        }
        let authority = Authority::of(folder)?;
        let revoked = lines(&folder.join(REVOKED))?;
        let mut issued = lines(&folder.join(ISSUED))?;
        let mut made = Vec::new();
        for holder in holders {
            let mut credentials = authority.certify(holder)?;
            issued.insert(credentials.identity()?.own().common_name.clone());
            // A certificate that is not listed could not be revoked.
            write_lines(&folder.join(ISSUED), &issued)?;
            credentials.revoked.clone_from(&revoked);
            credentials.write(&folder.join(&holder.name))?;
            made.push(credentials);
        }
        Ok(made)
    }

    /// Revokes all certificates of this name and removes their folder, so that a new one can be
    /// created. The revocation is effective wherever `revoked.txt` is copied to: beside each
    /// certificate, also in this folder.
    ///
    /// # Errors
    ///
    /// [`CredentialsError`].
    pub fn revoke(folder: &Path, name: &str) -> Result<(), CredentialsError> {
        let issued = lines(&folder.join(ISSUED))?;
        let own = |issued: &&String| issued.split('.').next() == Some(name);
        let mut revoked = lines(&folder.join(REVOKED))?;
        let before = revoked.len();
        revoked.extend(issued.iter().filter(own).cloned());
        if revoked.len() == before {
            return Err(CredentialsError::NotIssued {
                name: name.chars().take(60).collect(),
                folder: folder.display().to_string(),
            });
        }
        write_lines(&folder.join(REVOKED), &revoked)?;
        let of_name = folder.join(name);
        if of_name.is_dir() {
            fs::remove_dir_all(&of_name).map_err(|source| of_file(&of_name, source))?;
        }
        for common_name in issued.difference(&revoked) {
            let member = folder.join(common_name.split('.').next().unwrap_or_default());
            if member.is_dir() {
                write_lines(&member.join(REVOKED), &revoked)?;
            }
        }
        Ok(())
    }

    /// Returns a warning if the certificate expires soon.
    #[must_use]
    pub fn warning(&self) -> Option<String> {
        let peer = Peer::of(&der(&self.certificate).ok()?)?;
        let days = (peer.expires_s - now_s()) / 86400;
        (days < WARN_DAYS).then(|| {
            format!(
                "the certificate of {} in the fleet expires in {days} days; `dobot fleet revoke FOLDER {0}` and `dobot fleet certificates FOLDER {0}` replace it",
                peer.name
            )
        })
    }

    /// Whether these are a user's credentials for the programs on this machine.
    pub(crate) const fn is_local(&self) -> bool {
        self.is_local
    }

    /// Returns the revoked certificates by common name.
    pub(crate) const fn revoked(&self) -> &BTreeSet<String> {
        &self.revoked
    }

    /// Returns the file of revoked certificates; local credentials have none.
    pub(crate) fn revoked_file(&self) -> Option<&Path> {
        self.revoked_file.as_deref()
    }

    /// Returns the authority's certificate, the own certificate and its key, encoded for Zenoh.
    pub(crate) fn base64(&self) -> [String; 3] {
        [&self.authority, &self.certificate, &self.key].map(|pem| BASE64.encode(pem.as_bytes()))
    }

    /// Returns the identity that signs messages.
    pub(crate) fn identity(&self) -> Result<Identity, CredentialsError> {
        let key = KeyPair::from_pem(&self.key)?.serialize_der();
        let [authority, certificate] = [&self.authority, &self.certificate].map(|pem| der(pem));
        Identity::new(&authority?, certificate?, &key, self.revoked.clone())
    }

    fn write(&self, folder: &Path) -> Result<(), CredentialsError> {
        write(&folder.join(AUTHORITY), &self.authority)?;
        write(&folder.join(CERTIFICATE), &self.certificate)?;
        write(&folder.join(KEY), &self.key)?;
        write_lines(&folder.join(REVOKED), &self.revoked)
    }
}

// The key is a secret.
impl fmt::Debug for Credentials {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Credentials").finish_non_exhaustive()
    }
}

/// The holder of a certificate, and the hosts at which it is reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Holder {
    name: String,
    hosts: Vec<String>,
}

/// Parses `desk-3`, or `router=router.school,192.168.7.1` for a holder to which others connect by
/// those names and addresses.
impl FromStr for Holder {
    type Err = CredentialsError;

    fn from_str(text: &str) -> Result<Self, CredentialsError> {
        // Nobody connects to a station that joins through a router: its certificate has its name as
        // host.
        let (name, hosts) = text.split_once('=').unwrap_or((text, text));
        if !is_fleet_name(name) {
            return Err(CredentialsError::Name(name.chars().take(60).collect()));
        }
        let is_plain = |char: char| char.is_ascii_alphanumeric() || ".-:".contains(char);
        let hosts: Vec<String> = hosts.split(',').map(Into::into).collect();
        let wrong = |host: &&String| host.is_empty() || !host.chars().all(is_plain);
        if let Some(wrong) = hosts.iter().find(wrong) {
            return Err(CredentialsError::Host(wrong.chars().take(60).collect()));
        }
        Ok(Self {
            name: name.into(),
            hosts,
        })
    }
}

impl Holder {
    /// Returns the name of the holder.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

/// The authority of a fleet.
struct Authority {
    certificate: String,
    issuer: Issuer<'static, KeyPair>,
}

impl Authority {
    /// Returns the authority in the folder, creating it if necessary.
    fn of(folder: &Path) -> Result<Self, CredentialsError> {
        let [certificate, key] = [AUTHORITY, AUTHORITY_KEY].map(|name| folder.join(name));
        if !key.exists() {
            let pair = KeyPair::generate()?;
            write(&certificate, &authority().self_signed(&pair)?.pem())?;
            write(&key, &pair.serialize_pem())?;
        }
        Ok(Self {
            certificate: read(&certificate)?,
            issuer: Issuer::new(authority(), KeyPair::from_pem(&read(&key)?)?),
        })
    }

    /// Returns the authority of a folder that several programs may create concurrently: both files
    /// appear together or not at all.
    fn shared(folder: &Path) -> Result<Self, CredentialsError> {
        if !folder.exists() {
            let new = folder.with_extension(new_id().map_err(CredentialsError::Random)?);
            Self::of(&new)?;
            if let Err(source) = fs::rename(&new, folder) {
                // Another program may have created it first.
                drop(fs::remove_dir_all(&new));
                if !folder.exists() {
                    return Err(of_file(folder, source));
                }
            }
        }
        Self::of(folder)
    }

    fn certify(&self, holder: &Holder) -> Result<Credentials, CredentialsError> {
        let pair = KeyPair::generate()?;
        let mut params = CertificateParams::new(holder.hosts.clone())?;
        let serial = new_id().map_err(CredentialsError::Random)?;
        let common_name = format!("{}.{}", holder.name, &serial[..8]);
        params
            .distinguished_name
            .push(DnType::CommonName, common_name);
        // Valid from long ago: a computer without a clock battery may start in 1970.
        params.not_after = (SystemTime::now() + Duration::from_secs(DAYS * 86400)).into();
        let certificate = params.signed_by(&pair, &self.issuer)?;
        Ok(Credentials {
            authority: self.certificate.clone(),
            certificate: certificate.pem(),
            key: pair.serialize_pem(),
            revoked: BTreeSet::new(),
            revoked_file: None,
            is_local: false,
        })
    }
}

/// Returns the parameters of the authority's certificate.
fn authority() -> CertificateParams {
    let mut params = CertificateParams::default();
    let name = &mut params.distinguished_name;
    name.push(DnType::CommonName, "dobot fleet");
    params.is_ca = IsCa::Ca(BasicConstraints::Unconstrained);
    params
}

/// Decodes a PEM text that contains one certificate.
fn der(pem: &str) -> Result<Vec<u8>, CredentialsError> {
    let parsed = parse_x509_pem(pem.as_bytes());
    let unusable = |_| CredentialsError::Unusable("a certificate file is not in PEM format");
    parsed.map(|(_, pem)| pem.contents).map_err(unusable)
}

/// Returns the revoked certificates in a file if it has changed since `before`.
pub(crate) fn read_revoked(
    file: &Path,
    before: Option<SystemTime>,
) -> Option<(SystemTime, BTreeSet<String>)> {
    let changed = std::fs::metadata(file)
        .and_then(|metadata| metadata.modified())
        .ok()?;
    // An unreadable file changes nothing: revoked certificates stay revoked.
    let revoked = (Some(changed) != before).then(|| lines(file).ok())??;
    Some((changed, revoked))
}

fn lines(file: &Path) -> Result<BTreeSet<String>, CredentialsError> {
    if !file.exists() {
        return Ok(BTreeSet::new());
    }
    let text = read(file)?;
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    Ok(lines.map(Into::into).collect())
}

fn write_lines(file: &Path, lines: &BTreeSet<String>) -> Result<(), CredentialsError> {
    let text = lines
        .iter()
        .fold(String::new(), |text, line| text + line + "\n");
    write(file, &text)
}

fn read(file: &Path) -> Result<String, CredentialsError> {
    fs::read_to_string(file).map_err(|source| of_file(file, source))
}

fn write(file: &Path, text: &str) -> Result<(), CredentialsError> {
    write_private(file, text).map_err(|source| of_file(file, source))
}

fn of_file(file: &Path, source: std::io::Error) -> CredentialsError {
    CredentialsError::File {
        file: file.display().to_string(),
        source,
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    fn names(names: &[&str]) -> Vec<Holder> {
        names.iter().map(|holder| holder.parse().unwrap()).collect()
    }

    #[test]
    fn a_desk_added_later_gets_a_certificate_of_the_same_authority() {
        let folder = tempfile::tempdir().unwrap();
        let first = Credentials::make(folder.path(), &names(&["desk-1", "router"])).unwrap();
        let later = Credentials::make(folder.path(), &names(&["desk-2"])).unwrap();
        let [first, later] =
            [&first[0], &later[0]].map(|certificates| certificates.identity().unwrap());
        let peer = first.peer(later.certificate()).unwrap();
        assert_eq!(peer.name, "desk-2");
        Credentials::read(&folder.path().join("desk-2")).unwrap();
    }

    #[test]
    fn programs_of_one_person_share_an_authority_even_if_they_start_at_once() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("fleet-authority");
        let start = |name: &'static str| {
            let place = place.clone();
            std::thread::spawn(move || Credentials::local(&place, name).unwrap())
        };
        let all = ["desk-1", "desk-2", "desk-3", "desk-4"].map(start);
        let all = all.map(|thread| thread.join().unwrap().identity().unwrap());
        for one in &all {
            all[0].peer(one.certificate()).unwrap();
        }
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_certificate_is_valid_for_a_year_and_its_expiry_is_announced_thirty_days_before() {
        let folder = tempfile::tempdir().unwrap();
        let fresh = Credentials::make(folder.path(), &names(&["desk-1"])).unwrap();
        let days = (fresh[0].identity().unwrap().own().expires_s - now_s()) / 86400;
        assert!((364..=365).contains(&days), "{days}");
        assert_eq!(fresh[0].warning(), None);
        let old = ending_in_days(folder.path(), "desk-2", 29);
        let warning = old.warning().unwrap();
        assert!(
            warning.contains("desk-2 in the fleet expires in 2"),
            "{warning}"
        );
        let error = ending_in_days(folder.path(), "desk-3", 0)
            .identity()
            .unwrap_err();
        assert!(error.to_string().contains("it has expired"), "{error}");
    }

    /// A certificate of this authority that expires after this number of days.
    fn ending_in_days(folder: &Path, name: &str, days: u64) -> Credentials {
        let authority = Authority::of(folder).unwrap();
        let pair = KeyPair::generate().unwrap();
        let mut params = CertificateParams::new(vec![name.to_owned()]).unwrap();
        params.distinguished_name.push(DnType::CommonName, name);
        params.not_after = (SystemTime::now() + Duration::from_secs(days * 86400)).into();
        let certificate = params.signed_by(&pair, &authority.issuer).unwrap();
        Credentials {
            authority: authority.certificate,
            certificate: certificate.pem(),
            key: pair.serialize_pem(),
            revoked: BTreeSet::new(),
            revoked_file: None,
            is_local: false,
        }
    }

    #[test]
    fn a_revoked_certificate_is_refused_by_all_and_a_new_one_of_its_name_is_accepted() {
        let folder = tempfile::tempdir().unwrap();
        let made = Credentials::make(folder.path(), &names(&["desk-1", "desk-2"])).unwrap();
        let stick = made[1].identity().unwrap();
        Credentials::revoke(folder.path(), "desk-2").unwrap();
        let again = Credentials::make(folder.path(), &names(&["desk-2"])).unwrap();
        let other = Credentials::read(&folder.path().join("desk-1")).unwrap();
        let other = other.identity().unwrap();
        assert_eq!(
            other.peer(stick.certificate()).unwrap_err(),
            "it is revoked"
        );
        let again = again[0].identity().unwrap();
        other.peer(again.certificate()).unwrap();
        assert_eq!(
            again.peer(stick.certificate()).unwrap_err(),
            "it is revoked"
        );
        let error = Credentials::revoke(folder.path(), "desk-9").unwrap_err();
        assert!(
            matches!(error, CredentialsError::NotIssued { .. }),
            "{error}"
        );
    }

    #[test]
    fn a_key_does_not_appear_in_debug_output() {
        let folder = tempfile::tempdir().unwrap();
        let credentials = Credentials::local(&folder.path().join("own"), "desk-1").unwrap();
        assert_eq!(format!("{credentials:?}"), "Credentials { .. }");
    }

    #[test]
    fn a_refused_request_replaces_no_certificate_and_leaves_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        Credentials::make(folder.path(), &names(&["desk-1"])).unwrap();
        let error = Credentials::make(folder.path(), &names(&["desk-2", "desk-1"])).unwrap_err();
        assert!(
            error
                .to_string()
                .ends_with("desk-1 already exists; nothing was created")
        );
        assert!(!folder.path().join("desk-2").exists());
        let error = "../desk".parse::<Holder>().unwrap_err();
        assert!(matches!(error, CredentialsError::Name(_)), "{error}");
        for bad in ["router=", "router=a,", "router=a b", "router=*"] {
            let error = bad.parse::<Holder>().unwrap_err();
            assert!(matches!(error, CredentialsError::Host(_)), "{bad}: {error}");
        }
        let error = Credentials::read(&folder.path().join("desk-9")).unwrap_err();
        assert!(
            error.to_string().contains("authority.pem is missing"),
            "{error}"
        );
    }
}
